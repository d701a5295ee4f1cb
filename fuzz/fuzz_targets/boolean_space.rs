#![no_main]

coface_fuzz::target!(boolean_space);
