// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/source/SourceHeader.h"

#include <QString>
#include <QStringList>

#include <map>
#include <vector>

namespace core {

/// One measurement group (PS3.16 TID 1411) of a report.
struct SrFileGroup {
    QString name; ///< tracking identifier
    QString segUid;
    int segmentNumber = 0;
    QString sourceSeriesUid;
    /// By code value: that of the derivation if a number has one, else that of its concept.
    std::map<QString, double> numbers;
    QString graphicType; ///< graphic type of its positions in the patient; empty: it has none
    std::vector<float> graphicData; ///< x, y and z of each position, LPS mm
    QString frameOfReferenceUid; ///< frame of reference of these positions
};

/// The parts of a measurement report (TID 1500) that the check of exports compares.
struct SrFile {
    HeaderPatient patient;
    QString studyUid;
    QStringList evidence; ///< SOP instances
    std::vector<SrFileGroup> groups;
};

/// Errors: FileNotFound, FileUnreadable, UnsupportedFormat (not such a report).
[[nodiscard]] Result<SrFile> readSr(const QString& path);

} // namespace core
