// SPDX-License-Identifier: Apache-2.0
#include "core/volume/MemoryLimit.h"

#include <unistd.h>

namespace core {

Result<void> checkMemory(std::size_t voxels)
{
    const double total = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
    const double wanted = 2.0 * double(voxels);
    constexpr double share = 0.6;
    if (wanted <= share * total)
        return {};
    constexpr double gigabyte = 1e9;
    return failure(ErrorCode::OutOfMemory,
        QStringLiteral("the volume needs %1 GB, this machine has %2 GB")
            .arg(wanted / gigabyte, 0, 'f', 1)
            .arg(total / gigabyte, 0, 'f', 1));
}

} // namespace core
