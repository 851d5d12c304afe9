// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/EditKinds.h"

namespace core {

/// The kinds of edits that may name a file. Whoever reads a recipe reads these files with it, by an
/// overload for each kind (core/recipe/RecipeMasks.cpp); as long as one is missing, that does not
/// compile. A kind with a field for a file that is not in this list does not compile either
/// (EditNames.cpp).
using FileKinds = EditKinds<ImportMask, DivideSegment>;
template <class E>
concept isFileKind = (placeAmong<E>(FileKinds()) < FileKinds::count);

} // namespace core
