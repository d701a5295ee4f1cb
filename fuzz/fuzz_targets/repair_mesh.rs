#![no_main]

coface_fuzz::target!(repair_mesh);
