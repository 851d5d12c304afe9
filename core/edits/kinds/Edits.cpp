// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edits.h"

namespace core {

Edit::Edit() = default;
Edit::Edit(const Edit& other) = default;
Edit::Edit(Edit&& other) noexcept = default;
Edit& Edit::operator=(const Edit& other) = default;
Edit& Edit::operator=(Edit&& other) noexcept = default;
Edit::~Edit() = default;

} // namespace core
