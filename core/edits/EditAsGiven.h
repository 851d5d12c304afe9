// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

namespace core {

/// A row says more than was given: it also holds what its edit found when it was carried out
/// (FieldRole::Found). Without this, it is what was done, and finds it again, perhaps elsewhere.
[[nodiscard]] Edit asFirstGiven(Edit edit);

} // namespace core
