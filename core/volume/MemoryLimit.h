// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/words/Clause.h"

#include <QString>

#include <cstddef>

namespace core {

/// Checks that a volume of that many voxels, with 2 bytes each, fits into 60 % of the machine's
/// memory. The error OutOfMemory says how much is needed and how much there is.
[[nodiscard]] Result<void> checkMemory(std::size_t voxels);
/// The same for something that takes this number of bytes.
/// @param what what takes them, as a clause can begin with it: "the volume"
[[nodiscard]] Result<void> checkBytes(double bytes, const Clause& what);
/// The greatest number of bytes that checkBytes() allows.
[[nodiscard]] double allowedBytes();

/// While an object exists, allowedBytes() returns this number; for tests, so that small volumes
/// count as too large.
class AllowedBytes {
public:
    explicit AllowedBytes(double bytes);
    ~AllowedBytes();
    AllowedBytes(const AllowedBytes&) = delete;
    AllowedBytes& operator=(const AllowedBytes&) = delete;

private:
    double m_before;
};

} // namespace core
