#![no_main]

coface_fuzz::target!(read_amf);
