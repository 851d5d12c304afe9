// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/imports/ImportMask.h"
#include "core/session/operations/segments/WorkedOutOperation.h"

namespace core {

/// Carries out an ImportMask: the side thread unpacks its voxels, then the engine writes them.
class ImportOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit ImportOperation(ImportMask edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool foresee(Document& document) const override;
};

} // namespace core
