// SPDX-License-Identifier: Apache-2.0
#include "core/volume/MemoryLimit.h"

#include <atomic>

#include <unistd.h>

namespace core {

namespace {

double machinesBytes()
{
    return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
}

std::atomic<double> chosen = 0.0; // 0: a share of the machine's memory

} // namespace

double allowedBytes()
{
    constexpr double share = 0.6;
    const double bytes = chosen;
    return bytes > 0.0 ? bytes : share * machinesBytes();
}

AllowedBytes::AllowedBytes(double bytes)
    : m_before(chosen.exchange(bytes))
{
}

AllowedBytes::~AllowedBytes()
{
    chosen = m_before;
}

Result<void> checkBytes(double bytes, const Clause& what)
{
    if (bytes <= allowedBytes())
        return {};
    const double total = machinesBytes();
    constexpr double gigabyte = 1e9;
    return failure(ErrorCode::OutOfMemory,
        Clause::saying("%1 needs %2 GB, this machine has %3 GB", what,
            QString::number(bytes / gigabyte, 'f', 1), QString::number(total / gigabyte, 'f', 1)));
}

Result<void> checkMemory(std::size_t voxels)
{
    return checkBytes(2.0 * double(voxels), Clause::saying("the volume"));
}

} // namespace core
