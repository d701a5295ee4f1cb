#![no_main]

coface_fuzz::target!(check_certificate);
