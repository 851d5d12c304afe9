// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Do without a surface. What was not written back is lost with it, until this is undone.
struct DropSurface { };

} // namespace core
