"""THE table of public functions, by subject. Each module has groups in the order of the manual."""
