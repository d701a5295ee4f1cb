#![no_main]

coface_fuzz::target!(arrange_space);
