// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/DocumentOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/engine/EngineResult.h"

#include <utility>

namespace core {

DocumentOperation::DocumentOperation(Edit edit, RowId again)
    : m_edit(std::move(edit))
    , m_again(again)
{
}

void DocumentOperation::start(SessionState& state)
{
    m_done = true;
    if (m_again != 0) {
        state.complete(m_again, {});
        return;
    }
    Document after = state.document;
    const Result<bool> changed = applyToDocument(m_edit, after);
    if (!changed)
        state.fail(changed.error());
    else if (*changed)
        state.commit(m_edit, {}, {});
}

bool DocumentOperation::foresee(Document& document) const
{
    return bool(applyToDocument(m_edit, document));
}

} // namespace core
