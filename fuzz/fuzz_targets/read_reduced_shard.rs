#![no_main]

coface_fuzz::target!(read_reduced_shard);
