// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/SeedStatistics.h"
#include "core/volume/VoxelEncoding.h"

#include <QString>

#include <optional>

namespace core {

/// The codes of values between two bounds, both included; a bound that is not given is the end of
/// all codes.
/// Errors: InvalidField (bounds in the wrong order: the field "upper" below @p field).
[[nodiscard]] Result<CodeInterval> codesBetween(const QString& field,
    const std::optional<double>& lower, const std::optional<double>& upper,
    const VoxelEncoding& encoding);

} // namespace core
