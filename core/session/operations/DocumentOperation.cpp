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
    if (m_again != 0) {
        m_isCommitting = true;
        state.complete(m_again, {});
    } else {
        Document after = state.document;
        const Result<bool> changed = applyToDocument(m_edit, after);
        m_isCommitting = changed && *changed;
        if (!changed)
            state.fail(changed.error());
        else if (*changed)
            state.commit(m_edit, {}, {});
    }
    m_done = true;
}

bool DocumentOperation::abandon(SessionState& state, const Error& error)
{
    if (m_isCommitting || m_again != 0)
        return false;
    state.fail(error);
    m_done = true;
    return true;
}

bool DocumentOperation::foresee(Document& document) const
{
    return bool(applyToDocument(m_edit, document));
}

} // namespace core
