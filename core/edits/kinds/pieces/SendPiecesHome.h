// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Show every piece at its true place and in its true size.
struct SendPiecesHome { };

} // namespace core
