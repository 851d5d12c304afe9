// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class OFCondition;

namespace core {

/// Remembers the first failure in a chain of DCMTK calls. Only for sources of core/dicom.
class ConditionChain {
public:
    void operator()(const OFCondition& condition, const char* what);
    [[nodiscard]] bool good() const { return m_failure.isEmpty(); }
    [[nodiscard]] const QString& failure() const { return m_failure; }

private:
    QString m_failure;
};

} // namespace core
