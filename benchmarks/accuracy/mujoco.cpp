// SPDX-License-Identifier: BSD-3-Clause
//
// MuJoCo [todorov2012] by its integrator of highest order: a body on a ball joint, whose coordinates are a quaternion
// and the angular velocity in body axes.
#include "benchmarks/accuracy/contender.hpp"

#if KREISEL_MUJOCO
#include <mujoco/mujoco.h>

#include <cstring>
#include <stdexcept>
#endif

namespace accuracy {

#if KREISEL_MUJOCO

namespace {

constexpr const char* top_xml = R"(<mujoco>
  <option integrator="RK4" gravity="0 0 -9.81"/>
  <worldbody><body>
    <joint type="ball"/><inertial pos="0 1 0" mass="15" diaginertia="0.234375 0.46875 0.234375"/>
  </body></worldbody>
</mujoco>)";

mjModel* loaded_top() {
    mjVFS files;
    mj_defaultVFS(&files);
    const int size = static_cast<int>(std::strlen(top_xml));
    mj_makeEmptyFileVFS(&files, "top.xml", size);
    std::memcpy(files.filedata[mj_findFileVFS(&files, "top.xml")], top_xml, std::strlen(top_xml));
    char error[400] = "";
    mjModel* model = mj_loadXML("top.xml", &files, error, sizeof error);
    mj_deleteVFS(&files);
    if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error);
    return model;
}

class MujocoRun final : public Run {
  public:
    explicit MujocoRun(double steps) : steps_(static_cast<long>(steps)) {
        model_->opt.timestep = t_end / steps;
        for (int i = 0; i < 3; ++i) data_->qvel[i] = spin.at(static_cast<std::size_t>(i));
    }
    bool integrate() override {
        for (long i = 0; i < steps_; ++i) mj_step(model_.get(), data_.get());
        return true;
    }
    std::array<double, 3> position() const override {
        mj_forward(model_.get(), data_.get());
        const double* x = data_->xipos + 3;  // the world is body 0
        return {x[0], x[1], x[2]};
    }
    long evaluations() const override { return 4 * steps_; }

  private:
    long steps_;
    std::unique_ptr<mjModel, void (*)(mjModel*)> model_{loaded_top(), mj_deleteModel};
    std::unique_ptr<mjData, void (*)(mjData*)> data_{mj_makeData(model_.get()), mj_deleteData};
};

}  // namespace

std::vector<Contender> mujoco_contenders() {
    return {{Contender::Kind::engine, "MuJoCo RK4", true, ladder(16384, 2, 65536),
             [](double steps) { return std::make_unique<MujocoRun>(steps); }}};
}

#else

std::vector<Contender> mujoco_contenders() { return {}; }

#endif

}  // namespace accuracy
