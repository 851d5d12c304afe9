// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

namespace core {

/// An edit of the document alone. It is carried out at once and leaves one row if it changed
/// anything.
class DocumentOperation final : public Operation {
public:
    /// @param again as in VoxelOperation
    explicit DocumentOperation(Edit edit, RowId again = 0);
    void start(SessionState& state) override;
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    Edit m_edit;
    RowId m_again = 0;
    bool m_isCommitting = false; ///< the document may have changed
    bool m_done = false;
};

} // namespace core
