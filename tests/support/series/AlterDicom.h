// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QString>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <functional>

namespace test {

/// A fault for a file: changes its elements and stores it in the form that it had. Compares as a
/// test function does.
inline void alterDicom(const QString& file, const std::function<void(DcmDataset&)>& change)
{
    DcmFileFormat format;
    const QByteArray name = QFile::encodeName(file);
    QVERIFY(format.loadFile(name.constData()).good());
    DcmDataset& set = *format.getDataset();
    QVERIFY(set.loadAllDataIntoMemory().good());
    change(set);
    QVERIFY(format.saveFile(name.constData(), set.getOriginalXfer()).good());
}

} // namespace test
