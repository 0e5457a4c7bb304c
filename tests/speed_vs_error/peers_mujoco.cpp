// MuJoCo. Its contact is a spring and a damper when `solref` gives them as negative numbers, and
// `solimp` decides how much of the other acceleration a contact lets through: 1 - 1e-4 of it here.
// That is the course's law with contact=push-only, but for 1e-4 of gravity while they touch.

#include <mujoco/mujoco.h>

#include <cstring>
#include <stdexcept>

#include "speed_vs_error/engines.hpp"

namespace bounce::report {
namespace {

std::string model_text(double dt, const std::string& integrator) {
  return R"(<mujoco><option gravity="0 0 -9.81" timestep=")" + std::to_string(dt * 1e6) +
         R"(e-6" integrator=")" + integrator + R"("/>
  <worldbody>
    <geom name="floor" type="plane" size="10 10 1"/>
    <body pos="0 0 1"><freejoint/><geom name="ball" type="sphere" size="0.1" mass="1"/></body>
  </worldbody>
  <contact><pair geom1="floor" geom2="ball" condim="1" solref="-10000 -5"
                 solimp="0.0001 0.0001 0.001"/></contact></mujoco>)";
}

mjModel* load(const std::string& text) {
  mjVFS files;
  mj_defaultVFS(&files);
  const int size = static_cast<int>(text.size());
  if (mj_makeEmptyFileVFS(&files, "ball.xml", size) != 0) throw std::runtime_error("MuJoCo: VFS");
  std::memcpy(files.filedata[0], text.data(), text.size());
  char message[500] = "";
  mjModel* model = mj_loadXML("ball.xml", &files, message, sizeof message);
  mj_deleteVFS(&files);
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + message);
  return model;
}

class MujocoBall final : public EngineBall {
 public:
  MujocoBall(double dt, const std::string& integrator)
      : model_(load(model_text(dt, integrator))), data_(mj_makeData(model_)) {}
  MujocoBall(const MujocoBall&) = delete;
  MujocoBall& operator=(const MujocoBall&) = delete;
  ~MujocoBall() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  void drop() override { mj_resetData(model_, data_); }
  void step() override { mj_step(model_, data_); }
  double height() const override { return data_->qpos[2]; }
  double velocity() const override { return data_->qvel[2]; }

 private:
  mjModel* model_;
  mjData* data_;
};

}  // namespace

void add_mujoco(std::vector<Engine>& to) {
  for (const char* integrator : {"Euler", "RK4"}) {
    to.push_back({std::string("MuJoCo ") + integrator, mj_versionString(), Bounce::push_only_spring,
                  [=](double dt, double /*restitution*/) {
                    return std::make_unique<MujocoBall>(dt, integrator);
                  }});
  }
}

}  // namespace bounce::report
