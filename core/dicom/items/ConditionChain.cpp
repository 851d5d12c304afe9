// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/items/ConditionChain.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/ofstd/ofcond.h>

namespace core {

void ConditionChain::operator()(const OFCondition& condition, const char* what)
{
    if (condition.bad() && m_failure.isEmpty())
        m_failure = QStringLiteral("%1: %2").arg(
            QLatin1String(what), QString::fromLatin1(condition.text()));
}

} // namespace core
