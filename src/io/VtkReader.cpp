#include "io/VtkFile.h"

#include <cstring>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// Keeps the first message that VTK has instead of letting it go to the terminal.
void keepMessage(vtkObject*, unsigned long, void* kept, void* message)
{
    auto& text = *static_cast<std::string*>(kept);
    if (text.empty()) text = message ? static_cast<char const*>(message) : "unknown error";
}

std::string lastLine(std::string text)
{
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text.substr(text.find_last_of('\n') + 1);
}

vtkSmartPointer<vtkPolyData> read(std::filesystem::path const& path)
{
    Location const where{path.string(), 0, {}};
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw CaseError(ExitCode::InputOutput, where, "cannot read: no such file");
    std::string message;
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(keepMessage);
    observer->SetClientData(&message);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->AddObserver("ErrorEvent", observer);
    reader->GetExecutive()->AddObserver("ErrorEvent", observer);
    reader->SetReaderErrorObserver(observer);
    reader->SetParserErrorObserver(observer);
    reader->SetFileName(path.c_str());
    reader->Update();
    bool const failed = !message.empty() || reader->GetErrorCode() != 0;
    if (failed) throw CaseError(ExitCode::InputOutput, where, "VTK cannot read this file: " + lastLine(message));
    return reader->GetOutput();
}

Real timeOf(vtkPolyData& data)
{
    vtkDataArray* const time = data.GetFieldData()->GetArray("TimeValue");
    return time && time->GetNumberOfTuples() > 0 ? time->GetComponent(0, 0) : 0.0;
}

std::vector<Vector> vectorsOf(vtkDataArray& array)
{
    std::vector<Vector> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i) array.GetTuple(static_cast<vtkIdType>(i), values[i].data());
    return values;
}

std::vector<Vector> pointsOf(vtkPolyData& data)
{
    return data.GetNumberOfPoints() > 0 ? vectorsOf(*data.GetPoints()->GetData()) : std::vector<Vector>();
}

std::vector<Real> scalarsOf(vtkDataArray& array)
{
    std::vector<Real> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = array.GetComponent(static_cast<vtkIdType>(i), 0);
    return values;
}

/// All digits of 64-bit integers, which VTK's way through double would not keep.
std::vector<std::int64_t> integersOf(vtkDataArray& array)
{
    std::vector<std::int64_t> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    bool const wide = array.GetDataTypeSize() == 8;
    if (wide && !values.empty()) std::memcpy(values.data(), array.GetVoidPointer(0), 8 * values.size());
    for (std::size_t i = 0; !wide && i < values.size(); ++i)
        values[i] = static_cast<std::int64_t>(array.GetComponent(static_cast<vtkIdType>(i), 0));
    return values;
}

void takeArrays(vtkDataSetAttributes& from, NamedValues& to)
{
    for (int i = 0; i < from.GetNumberOfArrays(); ++i)
    {
        vtkDataArray* const array = from.GetArray(i);
        if (!array || !array->GetName()) continue;
        std::string const name = array->GetName();
        bool const real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
        if (array->GetNumberOfComponents() == 3)
            to.vectors[name] = vectorsOf(*array);
        else if (array->GetNumberOfComponents() == 1 && real)
            to.scalars[name] = scalarsOf(*array);
        else if (array->GetNumberOfComponents() == 1)
            to.integers[name] = integersOf(*array);
    }
}

std::vector<std::vector<std::int64_t>> cellsOf(vtkCellArray* array)
{
    std::vector<std::vector<std::int64_t>> cells;
    vtkNew<vtkIdList> points;
    for (vtkIdType i = 0; array && i < array->GetNumberOfCells(); ++i)
    {
        array->GetCellAtId(i, points);
        cells.emplace_back(points->begin(), points->end());
    }
    return cells;
}

} // namespace

PointCloudData readPointCloud(std::filesystem::path const& path)
{
    auto const data = read(path);
    PointCloudData cloud;
    cloud.time = timeOf(*data);
    cloud.position = pointsOf(*data);
    takeArrays(*data->GetPointData(), cloud);
    return cloud;
}

SurfaceData readSurface(std::filesystem::path const& path)
{
    auto const data = read(path);
    SurfaceData surface;
    surface.time = timeOf(*data);
    surface.points = pointsOf(*data);
    surface.lines = cellsOf(data->GetLines());
    surface.polygons = cellsOf(data->GetPolys());
    takeArrays(*data->GetCellData(), surface);
    return surface;
}

} // namespace mpsDem
