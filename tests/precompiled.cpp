// Compiles precompiled.h once for all programs.
#include "tests/precompiled.h"
