// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <chrono>
#include <vector>

namespace test {

/// One of the hostile files (HostileDicom.h), with a description.
struct HostileFile {
    QString name; ///< what it is
    QByteArray bytes;
};
[[nodiscard]] std::vector<HostileFile> hostileFiles();

/// A valid series to lie beside a hostile file: twelve slices in JPEG lossless.
constexpr int honestSlices = 12;
[[nodiscard]] QString honestSeriesUid();
/// Writes it.
/// @return its files, slice by slice
QStringList writeHonestSeries(const QString& folder);

/// The time after which a run counts as hung. It decides nothing else: only a hang takes that long
/// on an idle machine, while the issue allows ten seconds of work.
constexpr std::chrono::seconds hangsAfter{240};

/// The result of `burin`, run to its end or until it hangs.
struct WatchedRun {
    bool hung = false;
    int status = -1; ///< −1: it crashed
    double cpuSeconds = 0.0; ///< of all threads; compared with the ten seconds
    long peakKb = 0; ///< peak memory of the process, or of one that it started
    QByteArray output; ///< stdout
    QString complaint; ///< stderr
};
[[nodiscard]] WatchedRun watchedBurin(const QStringList& arguments);

} // namespace test
