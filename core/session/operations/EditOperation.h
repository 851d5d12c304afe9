// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

#include <memory>

namespace core {

/// Creates the operation that carries out a whole edit.
/// @param again a row that is carried out again when a session is opened; 0: a new row
[[nodiscard]] std::unique_ptr<Operation> operationOf(const Edit& edit, RowId again = 0);

/// Creates the operation of an edit that stands open until it is ended (canStandOpen()). Null:
/// edits of this kind are always carried out whole.
[[nodiscard]] std::unique_ptr<Operation> openOperationOf(const Edit& edit);

} // namespace core
