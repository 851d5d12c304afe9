// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"

#include <QString>

namespace core {

// Names of rows that change what a list of the document says: all that is different then, "Rename
// segment 1 to 'Bone', recolour it, lock it". @param document as it was before

[[nodiscard]] QString changeName(const ChangeSegment& edit, const Document& document);
[[nodiscard]] QString changeName(const ChangeLayer& edit, const Document& document);
[[nodiscard]] QString changeName(const ChangePiece& edit, const Document& document);

} // namespace core
