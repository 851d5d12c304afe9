// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// A segment that is made of a part of another one.
struct SplitPart {
    QString name{};
    std::uint32_t rgb = 0;
    bool operator==(const SplitPart&) const = default;
};

/// How many segments more there can be: numbers of deleted ones are not given again.
[[nodiscard]] std::size_t roomForSegments(const Document& document);

/// Names and colours for parts of a segment: "Liver 1", "Liver 2", …, as far as these are free, in
/// the colours that new segments have. Of a very long name they have the beginning.
[[nodiscard]] std::vector<SplitPart> usualParts(
    const Document& document, const Segment& segment, std::size_t count);

/// Adds the parts of a segment to the document, in its plane, behind all others. Errors:
/// InvalidField (there is no room for so many); then nothing was changed.
/// @param field that names them in recipes, such as "splitIslands.into"
Result<void> addParts(const char* field, const std::vector<SplitPart>& parts,
    const Segment& segment, Document& document);

} // namespace core
