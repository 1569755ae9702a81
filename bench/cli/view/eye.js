// The camera of a spatial picture. It shows everything until the reader turns or zooms.
import {PerspectiveCamera, Vector3} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';

const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};

export class Eye {
  // reach: the lower and upper corner of what is to be seen, about the origin. render: called when
  // the picture looks another way.
  constructor(stage, renderer, reach, render) {
    Object.assign(this, {stage, renderer, reach, render});
    this.camera = new PerspectiveCamera(30, 1, 0.01, 50);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, stage);
    this.controls.addEventListener('change', render);
    this.controls.addEventListener('start', () => { this.steered = true; });
    this.#steer();
    new ResizeObserver(() => this.#resize()).observe(stage);
  }

  // Shows everything, and goes on doing so until the reader turns or zooms.
  fit() {
    this.steered = false;
    this.#resize();
  }

  zoom(by) {
    this.steered = true;
    this.camera.position.sub(this.controls.target).divideScalar(by).add(this.controls.target);
    this.controls.update();
  }

  #aim() {
    const view = new Vector3(0.62, -1, 0.5).normalize();
    const right = new Vector3(1, 0.62, 0).normalize(), above = right.clone().cross(view).negate();
    const tall = Math.tan(Math.PI / 12), wide = tall * this.stage.clientWidth / this.stage.clientHeight;
    const x = new Vector3();
    let distance = 0.1;
    for (let corner = 0; corner < 8; ++corner) {
      x.fromArray([0, 1, 2].map(axis => this.reach[corner >> axis & 1][axis]));
      const far = Math.max(Math.abs(x.dot(right)) / wide, Math.abs(x.dot(above)) / tall);
      distance = Math.max(distance, 1.08 * far + x.dot(view) + 0.03);
    }
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(view).multiplyScalar(distance);
    this.controls.update();
  }

  #resize() {
    const {clientWidth: width, clientHeight: height} = this.stage;
    if (!this.steered) this.#aim();
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  // Arrow keys turn the camera while the picture has the focus.
  #steer() {
    this.stage.dataset.turns = 'true';
    this.stage.addEventListener('keydown', event => {
      const angle = turns[event.key];
      if (!angle || event.shiftKey) return;
      event.preventDefault();
      this.steered = true;
      const x = this.camera.position.clone().sub(this.controls.target), r = x.length();
      const turned = Math.atan2(x.y, x.x) + angle[0];
      const raised = Math.min(3.1, Math.max(0.04, Math.acos(x.z / r) + angle[1]));
      this.camera.position.set(Math.cos(turned) * Math.sin(raised), Math.sin(turned) * Math.sin(raised), Math.cos(raised))
          .multiplyScalar(r).add(this.controls.target);
      this.controls.update();
    });
  }
}
