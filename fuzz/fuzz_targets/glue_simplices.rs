#![no_main]

coface_fuzz::target!(glue_simplices);
