// Writes the parts of test_wireframe_step_case.py into a directory, as STEP files. Lengths are in millimetres.

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

void write(const TopoDS_Shape& shape, const std::string& path)
{
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone || writer.Write(path.c_str()) != IFSelect_RetDone)
  {
    std::cerr << "cannot write " << path << '\n';
    std::exit(1);
  }
}

TopoDS_Face polygon(const std::vector<gp_Pnt>& points)
{
  BRepBuilderAPI_MakePolygon result;
  for (const gp_Pnt& p : points)
    result.Add(p);
  result.Close();
  return BRepBuilderAPI_MakeFace(result.Wire());
}

TopoDS_Shape drilled_block()
{
  const gp_Ax2 axis(gp_Pnt(10, 8, -5), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20., 16., 10.).Shape(), BRepPrimAPI_MakeCylinder(axis, 3, 20).Shape())
    .Shape();
}

// one edge of the box, along z, is rounded with the radius 3
TopoDS_Shape rounded_block()
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20., 16., 10.).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer i(box, TopAbs_EDGE); i.More(); i.Next())
  {
    const TopoDS_Edge edge = TopoDS::Edge(i.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (a.X() == 0 && b.X() == 0 && a.Y() == 0 && b.Y() == 0)
    {
      fillet.Add(3, edge);
      break;
    }
  }
  return fillet.Shape();
}

// a cylinder cut askew: at 45 degrees through its axis at the height 20
TopoDS_Shape slanted_cylinder()
{
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 20), gp_Dir(0, 1, 0)), M_PI / 4);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-100, -100, 20), gp_Pnt(100, 100, 120)).Shape();
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(5, 60).Shape(), BRepBuilderAPI_Transform(box, turn).Shape()).Shape();
}

// a block whose upper side has a crease of 10 degrees
TopoDS_Shape creased_block()
{
  const double h = 10 - 10 * std::tan(5 * M_PI / 180);
  return BRepPrimAPI_MakePrism(
           polygon({gp_Pnt(0, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(20, 0, h), gp_Pnt(10, 0, 10), gp_Pnt(0, 0, h)}),
           gp_Vec(0, 12, 0))
    .Shape();
}

// two squares side by side that do not know of each other
TopoDS_Shape two_squares()
{
  TopoDS_Compound result;
  BRep_Builder builder;
  builder.MakeCompound(result);
  builder.Add(result, polygon({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(0, 10, 0)}));
  builder.Add(result, polygon({gp_Pnt(10, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(10, 10, 10), gp_Pnt(10, 0, 10)}));
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const std::string directory = std::string(argv[1]) + "/";
  write(drilled_block(), directory + "drilled_block.stp");
  write(rounded_block(), directory + "rounded_block.stp");
  write(slanted_cylinder(), directory + "slanted_cylinder.stp");
  write(creased_block(), directory + "creased_block.stp");
  write(two_squares(), directory + "two_squares.stp");
  write(BRepPrimAPI_MakeCone(5, 0, 8).Shape(), directory + "cone.stp");
  write(BRepPrimAPI_MakeSphere(5).Shape(), directory + "sphere.stp");
}
