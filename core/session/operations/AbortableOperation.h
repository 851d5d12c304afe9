// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

namespace core {

/// An operation that first works out on the side thread what is to be changed, which may take long.
class AbortableOperation : public Operation {
public:
    /// Until the engine begins to write: it ends with Cancelled and changes nothing.
    virtual void abort() = 0;
    [[nodiscard]] virtual bool isAbortable() const = 0;
    /// How much of the work on the side thread is done; less than 0 before it has begun, or where
    /// nobody knows.
    [[nodiscard]] virtual int percent() const = 0;
};

} // namespace core
