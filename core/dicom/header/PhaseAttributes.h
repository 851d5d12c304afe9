// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/dicom/items/HeaderAttributes.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace core {

class FunctionalGroups;

/// The number of attributes that may distinguish images at one position: temporal position, echo,
/// b-value …
[[nodiscard]] std::size_t phaseAttributeCount();

/// One value of such an attribute: "trigger time 160 ms".
[[nodiscard]] Clause phaseText(std::size_t attribute, const QString& value);

/// Whether the order of the values is meaningful; otherwise they merely differ.
[[nodiscard]] bool phaseHasOrder(std::size_t attribute);

/// The values of a single-frame object, most significant first; empty if absent. Only for sources
/// of core/dicom.
[[nodiscard]] std::vector<QString> readPhases(const HeaderAttributes& from);

/// The values of one frame of a multi-frame object, in the same order.
/// @param whole the result of readPhases() for the object
/// @param inStackIndex which of the frame's dimension indices states its position; −1: none
[[nodiscard]] std::vector<QString> readFramePhases(const FunctionalGroups& groups,
    std::size_t frame, const QByteArray& characterSet, std::vector<QString> whole,
    int inStackIndex);

} // namespace core
