// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Gives a piece its number and appends it to the list. Errors: InvalidField (the list is full).
/// @param edit its name, for the error
Result<bool> appendPiece(Piece piece, const char* edit, Document& document);

} // namespace core
