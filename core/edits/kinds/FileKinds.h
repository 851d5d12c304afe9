// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/EditKinds.h"

namespace core {

/// The kinds of edits that may name a file. A recipe that names one is read together with it
/// (core/recipe/RecipeMasks.cpp), which is asked by overloads for all of them, so that a kind that
/// is added does not compile until it answers. That it is added, EditNames.cpp demands.
using FileKinds = EditKinds<ImportMask, DivideSegment>;
template <class E>
concept isFileKind = (placeAmong<E>(FileKinds()) < FileKinds::count);

} // namespace core
