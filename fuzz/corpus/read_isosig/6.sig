# names
bkaaid sphere
