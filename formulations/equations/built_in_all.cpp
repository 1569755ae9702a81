#include "formulations/equations/tables_of.h"

namespace desmo {

std::span<const KernelTables> built_in_kernels() {
  static const KernelTables tables[] = {tables_of<KernelSet::cases>(),
                                        tables_of<KernelSet::library>()};
  return tables;
}

}  // namespace desmo
