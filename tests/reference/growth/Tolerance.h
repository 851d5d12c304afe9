// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/Tolerance.h"
#include "tests/reference/fields/DenseFields.h"

#include <optional>

namespace reference {

/// What came of a core::ToleranceRule.
struct ToleranceField {
    DenseArray<std::uint16_t> tolerances; ///< above ToleranceRule::greatest: none
    core::ToleranceCurve curve;

    [[nodiscard]] std::optional<int> at(const glm::ivec3& voxel) const;
};

/// @param coverage of the composed layers. Errors: InvalidField (a rule that is not sound, or a
/// label without seeds).
core::Result<ToleranceField> traceTolerance(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> coverage, DenseFields& fields, const core::ToleranceRule& rule);

} // namespace reference
