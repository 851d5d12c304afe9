// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

namespace core {

// What check() of several edits is made of.

/// A stroke into a layer that is not there or not seen would be lost work. Errors: InvalidField.
/// @param field for the error
[[nodiscard]] Result<void> checkLayer(const char* field, int id, const Document& document);

template <class T> [[nodiscard]] Result<void> discardValue(const Result<T>& result)
{
    if (!result)
        return tl::unexpected(result.error());
    return {};
}

/// Whether what an edit changes in a document could be changed.
template <class E> [[nodiscard]] Result<void> checkApplied(const E& edit, const Document& document)
{
    Document copy = document;
    return discardValue(apply(edit, copy));
}

} // namespace core
