#![no_main]

coface_fuzz::target!(read_vtk_appended);
