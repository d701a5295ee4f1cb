#![no_main]

coface_fuzz::target!(edit_halfedges);
