// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Gives a piece its number and puts it to the end of the list. Errors: InvalidField (there are as
/// many as there may be). @param edit its name, for the error
Result<bool> appendPiece(Piece piece, const char* edit, Document& document);

} // namespace core
