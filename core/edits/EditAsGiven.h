// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

namespace core {

/// The edit as the user gave it. The edit of a row also holds what it found when it was carried out
/// (fields of FieldRole::Found); without these it can be carried out on another study, where it
/// finds something else.
[[nodiscard]] Edit asFirstGiven(Edit edit);

} // namespace core
