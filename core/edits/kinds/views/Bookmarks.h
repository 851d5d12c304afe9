// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <glm/glm.hpp>

namespace core {

/// Keep a view of the patient under a name.
struct AddBookmark {
    QString name{};
    OrthographicView view{}; ///< of the 3D view
    glm::dvec3 crosshairLps{0.0};
};

struct RemoveBookmark {
    int bookmark = 0; ///< id
};

[[nodiscard]] Result<void> check(const AddBookmark& edit, const Document& document);
Result<bool> apply(const AddBookmark& edit, Document& document);
[[nodiscard]] EditEffects effects(const AddBookmark& edit);
[[nodiscard]] RowTitle rowTitle(const AddBookmark& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const AddBookmark& edit, const DependencyFacts& row);

[[nodiscard]] Result<void> check(const RemoveBookmark& edit, const Document& document);
Result<bool> apply(const RemoveBookmark& edit, Document& document);
[[nodiscard]] EditEffects effects(const RemoveBookmark& edit);
[[nodiscard]] RowTitle rowTitle(const RemoveBookmark& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const RemoveBookmark& edit, const DependencyFacts& row);

} // namespace core
