#![no_main]

coface_fuzz::target!(ask_polygons);
