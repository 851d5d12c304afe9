// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/HeaderAttributes.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace core {

class FunctionalGroups;

/// How many attributes may tell images at one position apart: temporal position, echo, b-value …
[[nodiscard]] std::size_t phaseAttributeCount();

/// One value of such an attribute in words: "trigger time 160 ms".
[[nodiscard]] QString phaseText(std::size_t attribute, const QString& value);

/// Whether the values have an order that means something; others merely differ.
[[nodiscard]] bool phaseHasOrder(std::size_t attribute);

/// The values of a single-frame object, most telling first; empty where absent. Only for sources of
/// core/dicom.
[[nodiscard]] std::vector<QString> readPhases(const HeaderAttributes& from);

/// The values of one frame of a multi-frame object, in the same order.
/// @param whole what readPhases() gives for the object
/// @param inStackIndex which of the frame's dimension indices tells its place; -1: none does
[[nodiscard]] std::vector<QString> readFramePhases(const FunctionalGroups& groups,
    std::size_t frame, const QByteArray& characterSet, std::vector<QString> whole,
    int inStackIndex);

} // namespace core
