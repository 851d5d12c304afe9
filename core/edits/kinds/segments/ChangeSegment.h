// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace core {

/// Rename, recolour, code or lock a segment, or protect it from sculpting; absent fields do not
/// change.
struct ChangeSegment {
    int segment = 0; ///< label
    std::optional<QString> name{};
    std::optional<std::uint32_t> rgb{};
    std::optional<CodedConcept> code{};
    std::optional<bool> locked{};
    std::optional<bool> uncarvable{};
};

[[nodiscard]] Result<void> check(const ChangeSegment& edit, const Document& document);
Result<bool> apply(const ChangeSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangeSegment& edit);
[[nodiscard]] RowTitle rowTitle(const ChangeSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ChangeSegment& edit, const DependencyFacts& row);

} // namespace core
