// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace core {

/// The criteria of a search for studies; empty fields match everything. `*` and `?` are wildcards,
/// except in UIDs.
struct StudyFilter {
    QString patientName;
    QString patientId;
    QString studyDate; ///< "20240131", or a range: "20240101-20241231", "20240101-"
    QString modality; ///< the study contains a series of it
    QString accessionNumber;
    QString description;
    QString studyUid;
};

/// A study as its node describes it. Dates as "2024-01-31"; counts are −1 if unknown.
struct StudyHit {
    QString studyUid;
    QString patientName;
    QString patientId;
    QString birthDate;
    QString studyDate;
    QString accessionNumber;
    QString description;
    QStringList modalities;
    int series = -1;
    int instances = -1;
};

/// A series as its node describes it.
struct SeriesHit {
    QString studyUid;
    QString seriesUid;
    QString modality;
    QString number;
    QString description;
    QString bodyPart;
    int instances = -1;
};

/// An object as its node describes it.
struct InstanceHit {
    QString sopInstanceUid;
    QString sopClassUid; ///< empty if unknown
    int number = -1; ///< in its series; −1 if unknown
};

/// The results of a search.
template <class Hit> struct HitList {
    std::vector<Hit> hits;
    bool more = false; ///< the node has more than were requested
};

/// Whether the node answers (C-ECHO). Errors as of Association::request(), NodeFailed.
[[nodiscard]] Result<void> echoNode(const PacsNode& node, const Progress& progress);

/// Searches for studies (C-FIND). Blocks; call it on a worker thread.
/// @param most if there are more, the rest of the answer is cancelled
/// Errors: those of Association::request(), NodeFailed.
[[nodiscard]] Result<HitList<StudyHit>> findStudies(
    const PacsNode& node, const StudyFilter& filter, int most, const Progress& progress);
[[nodiscard]] Result<std::vector<SeriesHit>> findSeries(
    const PacsNode& node, const QString& studyUid, const Progress& progress);
/// Empty if the node does not support this query; some do not.
[[nodiscard]] Result<std::vector<InstanceHit>> findInstances(const PacsNode& node,
    const QString& studyUid, const QString& seriesUid, const Progress& progress);

} // namespace core
