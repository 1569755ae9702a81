// Moves what is linked after it by 16 bytes past a multiple of cache line and page: another place
// in memory for the same code (see bench/check --certify).
asm(".text\n\t.p2align 12\n\t.skip 16, 0x90");
