#![no_main]

coface_fuzz::target!(parse_words);
