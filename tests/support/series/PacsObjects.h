// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/pacs/PacsQuery.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"

#include <QString>
#include <QStringList>

// Objects that tests send to servers and search for there, by any protocol.

namespace test {

/// All files below a folder, including hidden ones.
[[nodiscard]] QStringList filesBelow(const QString& folder);

/// Two studies of three images each that a search can distinguish: Müller^Jörg (A1, CT, 2020-03-04)
/// and Doe^Jane (B2, MR, 2021-05-06).
struct TwoStudies {
    /// Written below @p folder.
    explicit TwoStudies(const QString& folder);

    SyntheticSeries first;
    SyntheticSeries second;
    QStringList files;
};

/// A DICOM SEG of one segment, written in a folder beside its series.
struct SmallMask {
    explicit SmallMask(const QString& folder);

    QString file;
    QString studyUid;
    QString sha256; ///< as reported by the export
    QString problem; ///< why it could not be made
};

/// Checks that a server with two studies finds each by its distinguishing attributes, and nothing
/// for others.
/// @param alone whether the server holds no other studies
template <class Node> void compareSearch(const Node& node, const TwoStudies& studies, bool alone)
{
    const auto found = [&node](const core::StudyFilter& filter, int most = 100) {
        return core::findStudies(node, filter, most, core::Progress());
    };
    const auto all = found({});
    VERIFY_DONE(all);
    QVERIFY(alone ? all->hits.size() == 2 : all->hits.size() >= 2);
    QVERIFY(!all->more);
    const auto byName = found({.patientName = QStringLiteral("Do*")});
    VERIFY_DONE(byName);
    QCOMPARE(byName->hits.size(), std::size_t(1));
    const core::StudyHit& jane = byName->hits.front();
    QCOMPARE(jane.studyUid, studies.second.studyUid);
    QCOMPARE(jane.patientName, QStringLiteral("Doe^Jane"));
    QCOMPARE(jane.patientId, QStringLiteral("B2"));
    QCOMPARE(jane.studyDate, QStringLiteral("2021-05-06"));
    // By its number: Debian's Orthanc decodes no %C3%BC in an address.
    const auto byId = found({.patientId = QStringLiteral("A1")});
    VERIFY_DONE(byId);
    QCOMPARE(byId->hits.size(), std::size_t(1));
    QCOMPARE(byId->hits.front().patientName, QStringLiteral("Müller^Jörg"));
    for (const char* dates : {"20210101-20211231", "20210101-"}) {
        // What else it holds may be of a later year.
        if (!alone && QLatin1String(dates).endsWith(QLatin1Char('-')))
            continue;
        const auto byDate = found({.studyDate = QLatin1String(dates)});
        VERIFY_DONE(byDate);
        QCOMPARE(byDate->hits.size(), std::size_t(1));
        QCOMPARE(byDate->hits.front().studyUid, studies.second.studyUid);
    }
    const auto nobody = found({.patientId = QStringLiteral("C3")});
    VERIFY_DONE(nobody);
    QVERIFY(nobody->hits.empty());
    const auto few = found({}, 1);
    VERIFY_DONE(few);
    QCOMPARE(few->hits.size(), std::size_t(1));
    QVERIFY(few->more);

    const auto series = core::findSeries(node, studies.second.studyUid, core::Progress());
    VERIFY_DONE(series);
    QCOMPARE(series->size(), std::size_t(1));
    QCOMPARE(series->front().seriesUid, studies.second.seriesUid);
    QCOMPARE(series->front().modality, QStringLiteral("MR"));
    const auto instances = core::findInstances(
        node, studies.second.studyUid, studies.second.seriesUid, core::Progress());
    VERIFY_DONE(instances);
    QCOMPARE(instances->size(), std::size_t(3));
}

} // namespace test
